// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// a simulation goes on from a checkpoint to the bits that it would have had, whoever wrote it and whoever reads it

#include "bubbles.h"

#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/simulate_distributed.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <memory>
#include <utility>
#include <vector>

namespace {

using namespace bubbles;
namespace fs = std::filesystem;
namespace P = CGAL::parameters;

/// some ranks only: the first `n` of all
class First_ranks
{
public:
  First_ranks(int n)
  {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_split(MPI_COMM_WORLD, rank < n ? 0 : MPI_UNDEFINED, rank, &m_comm);
  }
  ~First_ranks()
  {
    if (m_comm != MPI_COMM_NULL)
      MPI_Comm_free(&m_comm);
    MPI_Barrier(MPI_COMM_WORLD); // what they wrote is there
  }
  First_ranks(const First_ranks&) = delete;
  First_ranks& operator=(const First_ranks&) = delete;

  bool has_this() const { return m_comm != MPI_COMM_NULL; }
  MPI_Comm handle() const { return m_comm; }

private:
  MPI_Comm m_comm = MPI_COMM_NULL;
};

/// a directory of this run for the files of a test; the first rank makes and removes it
class Directory
{
public:
  Directory()
  {
    MPI_Comm_rank(MPI_COMM_WORLD, &m_rank);
    std::array<char, 256> text{};
    if (m_rank == 0) {
      std::string name = (fs::temp_directory_path() / "bubble_checkpoint_XXXXXX").string();
      if (mkdtemp(&name[0]) == nullptr || name.size() >= text.size())
        MPI_Abort(MPI_COMM_WORLD, 1);
      std::copy(name.begin(), name.end(), text.begin());
    }
    MPI_Bcast(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
    m_path = text.data();
  }
  ~Directory()
  {
    MPI_Barrier(MPI_COMM_WORLD);
    std::error_code ignored;
    if (m_rank == 0)
      fs::remove_all(m_path, ignored);
  }
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;

  std::string file(const std::string& name) const { return m_path + "/" + name; }

  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_path), fs::directory_iterator()));
  }

private:
  std::string m_path;
  int m_rank = 0;
};

std::vector<char> bytes_of(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return std::vector<char>(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

/// by the first rank, for all
void write_bytes(const std::string& path, const std::vector<char>& bytes)
{
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0)
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  MPI_Barrier(MPI_COMM_WORLD);
}

constexpr std::size_t most_rounds = 20; // so many that rest is coarse at first, whatever they come to

struct Result
{
  Placed_part_2 part;
  Report report; // of one rank
};

/// stops in the round after so many
Progress stop_after(std::size_t rounds)
{
  struct Round_counter : Observer
  {
    std::size_t number = 0;
    void phase_begins(CGAL::Bubble_phase) override {}
    void step_ends(const Bubbles_2&) override {}
    void round_ends(const Report&) override { ++number; }
  };
  auto counter = std::make_unique<Round_counter>();
  const Round_counter& counted = *counter;
  return Progress([&counted, rounds](double) { return counted.number < rounds; }, std::move(counter));
}

template <class Size, class NamedParameters>
Result simulate(Communicator& ranks, const paper::Domain& domain, const Size& size, const NamedParameters& parameters,
                Progress progress = Progress())
{
  const auto np = parameters.sizing_function(size);
  Case c{paper::triangulate(domain), nullptr, {}};
  c.read(np);
  Relaxation_options& options = c.input->options;
  if (options.number_of_rounds == default_number_of_rounds)
    options.number_of_rounds = most_rounds;
  if (progress.is_heard())
    *options.progress = std::move(progress);
  options.progress->remember_stop();
  Report report;
  Placed_part_2 part = simulate_distributed(ranks, c.input->problem(), report);
  return Result{std::move(part), report};
}

/// all bubbles and all counts as one number, which is the same for any number of ranks
std::uint64_t fingerprint(Communicator& comm, const Result& result)
{
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < result.part.bubbles.size(); ++i) {
    const Bubble_record_2 r = record(result.part.bubbles, i);
    Hash_of_numbers hash;
    for (double x : {r.x, r.y, r.d, r.vx, r.vy, r.s})
      hash.add(x);
    hash.add(r.id);
    for (std::int32_t k : {r.host, r.pin, r.dimension})
      hash.add(k);
    sum += hash.value();
  }
  const Report& r = result.report;
  Hash_of_numbers hash;
  hash.add(comm.sum(sum));
  for (std::size_t n : {r.number_of_moves, r.number_of_returns, r.number_of_insertions, r.number_of_deletions})
    hash.add(comm.sum(static_cast<std::int64_t>(n)));
  for (std::size_t n : {r.number_of_initial_bubbles, r.number_of_rounds, r.number_of_steps,
                        r.number_of_force_evaluations, r.number_of_renewals})
    hash.add(n);
  hash.add(r.stop_reason);
  return hash.value();
}

paper::Domain domain(int k) { return paper::all_domains(1)[static_cast<std::size_t>(k)]; }

template <class Exception, class Function>
void expect_all_throw(const Function& f, const std::string& text)
{
  try {
    f();
    ADD_FAILURE() << "nothing was thrown: " << text;
  } catch (const Exception& e) {
    EXPECT_NE(std::string(e.what()).find(text), std::string::npos) << e.what();
  } catch (const std::exception& e) {
    ADD_FAILURE() << "another exception was thrown: " << e.what();
  }
}

/// writes a checkpoint after some rounds by the first ranks only
void write_by_first_ranks(int n, const paper::Domain& d, const std::string& path, std::size_t rounds)
{
  const First_ranks first(n);
  if (!first.has_this())
    return;
  Communicator some(first.handle());
  const Report stopped = simulate(some, d, d.d, P::checkpoint(path, rounds), stop_after(rounds)).report;
  EXPECT_EQ(stopped.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
  EXPECT_EQ(stopped.number_of_rounds, rounds + 1);
}

TEST(Checkpoint, an_interrupted_simulation_goes_on_to_the_same_bits)
{
  Communicator ranks{MPI_COMM_WORLD};
  const Directory directory;
  const paper::Domain d = domain(2);
  const std::string last = directory.file("last"), by_one = directory.file("by_one"), by_all = directory.file("by_all");
  const Result whole = simulate(ranks, d, d.d, P::checkpoint(last, 1));
  const std::uint64_t expected = fingerprint(ranks, whole);
  const std::vector<char> last_bytes = bytes_of(last);
  const std::size_t end = whole.report.number_of_rounds;
  ASSERT_GT(end, 3u);
  EXPECT_GT(ranks.sum(static_cast<std::int64_t>(whole.report.number_of_deletions)), 0) << "numbers have gaps";
  const std::size_t stride = ranks.size() == 1 ? 1 : (end - 1) / 2; // one rank is fast
  for (std::size_t rounds = 1; rounds < end; rounds += stride) {
    SCOPED_TRACE(rounds);
    write_by_first_ranks(1, d, by_one, rounds);
    const Result by_others = simulate(ranks, d, d.d, P::restart_from(by_one).checkpoint(by_all, 1));
    EXPECT_EQ(fingerprint(ranks, by_others), expected);
    if (rounds + 1 < end) {
      EXPECT_TRUE(bytes_of(by_all) == last_bytes) << "the last checkpoint is another one";
    }
  }
  write_by_first_ranks((ranks.size() + 1) / 2, d, by_all, end / 2);
  write_by_first_ranks(1, d, by_one, end / 2);
  EXPECT_TRUE(bytes_of(by_one) == bytes_of(by_all)) << "another number of ranks writes another file";
  const First_ranks one(1);
  if (one.has_this()) {
    Communicator alone(one.handle());
    EXPECT_EQ(fingerprint(alone, simulate(alone, d, d.d, P::restart_from(by_all))), expected);
  }
}

TEST(Checkpoint, of_the_paper)
{
  Communicator ranks{MPI_COMM_WORLD};
  const Directory directory;
  const paper::Domain d = paper::all_domains(1.5)[3];
  const std::string path = directory.file("a");
  const auto np = CGAL::npbs_paper_parameters().number_of_rounds(4).number_of_iterations(15);
  const std::uint64_t expected = fingerprint(ranks, simulate(ranks, d, d.d, np));
  {
    const First_ranks one(1);
    if (one.has_this()) {
      Communicator alone(one.handle());
      simulate(alone, d, d.d, np.checkpoint(path, 2), stop_after(2));
    }
  }
  EXPECT_EQ(fingerprint(ranks, simulate(ranks, d, d.d, np.restart_from(path))), expected);
}

/// a file after the first round, and what becomes of an attempt to go on from it or from another one
struct Checkpoint_of_trunk : testing::Test
{
  Communicator ranks{MPI_COMM_WORLD};
  const Directory directory;
  const paper::Domain trunk = domain(4);
  const std::string path = directory.file("good"), bad = directory.file("bad");
  std::vector<char> good;

  Checkpoint_of_trunk()
  {
    write_by_first_ranks(1, trunk, path, 1);
    good = bytes_of(path);
  }

  template <class NamedParameters>
  auto attempt(const NamedParameters& np)
  {
    return [this, np] { simulate(ranks, trunk, trunk.d, np); };
  }
};

TEST_F(Checkpoint_of_trunk, is_refused_unless_it_is_whole)
{
  const auto go_on = attempt(P::restart_from(bad));
  expect_all_throw<std::runtime_error>(go_on, bad);
  write_bytes(bad, {});
  expect_all_throw<std::invalid_argument>(go_on, "is no checkpoint");
  write_bytes(bad, std::vector<char>(1000, 'x'));
  expect_all_throw<std::invalid_argument>(go_on, "is no checkpoint");
  for (const std::size_t size : {good.size() - 1, good.size() - 112, good.size() / 2, sizeof(Checkpoint_header_2),
                                 std::size_t(100), std::size_t(8)}) {
    write_bytes(bad, std::vector<char>(good.begin(), good.begin() + std::ptrdiff_t(size)));
    expect_all_throw<std::runtime_error>(go_on, "truncated");
  }
  std::vector<char> longer = good;
  longer.push_back(0);
  write_bytes(bad, longer);
  expect_all_throw<std::runtime_error>(go_on, "altered");
  for (std::size_t place = 20; place < good.size(); place += good.size() / 9) {
    std::vector<char> altered = good;
    altered[place] = static_cast<char>(altered[place] ^ 4);
    write_bytes(bad, altered);
    expect_all_throw<std::runtime_error>(go_on, "altered");
  }
  std::vector<char> swapped = good;
  const auto second = swapped.begin() + std::ptrdiff_t(sizeof(Checkpoint_header_2) + 112);
  std::swap_ranges(second - 112, second, second);
  write_bytes(bad, swapped);
  expect_all_throw<std::runtime_error>(go_on, "altered");
  for (const std::size_t place : {8, 12}) { // byte order and version
    std::vector<char> other = good;
    std::reverse(other.begin() + std::ptrdiff_t(place), other.begin() + std::ptrdiff_t(place) + 4);
    write_bytes(bad, other);
    expect_all_throw<std::invalid_argument>(go_on, place == 8 ? "order of bytes" : "version");
  }
}

TEST_F(Checkpoint_of_trunk, is_refused_by_another_simulation)
{
  expect_all_throw<std::invalid_argument>(attempt(P::restart_from(path).damping(0.4)), "another damping: 0.6");
  expect_all_throw<std::invalid_argument>(attempt(P::restart_from(path).number_of_iterations(29)),
                                          "another number_of_iterations");
  expect_all_throw<std::invalid_argument>(attempt(P::restart_from(path).number_of_rounds(1)), "number_of_rounds is 1");
  const paper::Domain other = domain(0);
  expect_all_throw<std::invalid_argument>([&] { simulate(ranks, other, trunk.d, P::restart_from(path)); },
                                          "another domain");
  const auto larger_somewhere = [this](const Point& p) { return trunk.d(p) * (p.x() > 0.5 ? 1.001 : 1.); };
  expect_all_throw<std::invalid_argument>([&] { simulate(ranks, trunk, larger_somewhere, P::restart_from(path)); },
                                          "another sizing function");
  const auto throwing = [this](const Point& p) {
    if (p.x() > 0.51 && p.x() < 0.53)
      throw std::domain_error("no d here");
    return trunk.d(p);
  };
  expect_all_throw<std::domain_error>([&] { simulate(ranks, trunk, throwing, P::restart_from(path)); }, "no d here");
  if (ranks.size() > 1)
    expect_all_throw<std::invalid_argument>(attempt(P::restart_from(ranks.rank() == 0 ? path : bad)),
                                            "not the same on all ranks");
}

TEST_F(Checkpoint_of_trunk, more_rounds_than_planned_and_another_callback_are_fine)
{
  int calls = 0;
  const auto count = [&calls](double) { return ++calls > 0; };
  const Result result = simulate(ranks, trunk, trunk.d, P::restart_from(path).number_of_rounds(25).callback(count));
  EXPECT_GT(calls, 0);
  EXPECT_GT(result.report.number_of_rounds, 1u);
  EXPECT_NE(result.report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
}

TEST_F(Checkpoint_of_trunk, that_cannot_be_written_leaves_the_last)
{
  // found before anything is done
  int calls = 0;
  const auto count = [&calls](double) { return ++calls > 0; };
  expect_all_throw<std::invalid_argument>(attempt(P::checkpoint(directory.file("none/a"), 1).callback(count)),
                                          "none/a");
  EXPECT_EQ(calls, 0);
  // in the middle
  const std::string obstacle = path + ".part";
  const auto obstruct = [&](double progress) {
    if (ranks.rank() == 0 && progress > 0)
      fs::create_directories(obstacle + "/full");
    return true;
  };
  expect_all_throw<std::runtime_error>(attempt(P::checkpoint(path, 1).callback(obstruct)), obstacle);
  EXPECT_TRUE(bytes_of(path) == good);
  MPI_Barrier(MPI_COMM_WORLD);
  if (ranks.rank() == 0)
    fs::remove_all(obstacle);
  MPI_Barrier(MPI_COMM_WORLD);
  // what was left by a crash is in nobody's way, and all ranks may replace a checkpoint of one
  write_bytes(obstacle, std::vector<char>(2 * good.size(), 'x'));
  write_bytes(path, {});
  write_by_first_ranks(ranks.size(), trunk, path, 1);
  EXPECT_TRUE(bytes_of(path) == good);
  EXPECT_EQ(directory.number_of_files(), 1u);
  // and a file that is whole but cannot be renamed does not stay
  const std::string taken = directory.file("taken");
  MPI_Barrier(MPI_COMM_WORLD);
  if (ranks.rank() == 0)
    fs::create_directories(taken + "/full");
  MPI_Barrier(MPI_COMM_WORLD);
  expect_all_throw<std::runtime_error>(attempt(P::checkpoint(taken, 1)), "cannot be renamed");
  EXPECT_FALSE(fs::exists(taken + ".part"));
}

} // namespace
