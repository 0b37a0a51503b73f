// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_MESH_FILE_H
#define BUBBLE_RELAXATION_2_DEMO_MESH_FILE_H

#include "file_names.h"

#include <CGAL/Bubble_relaxation_2/IO/2DM.h>
#include <CGAL/Bubble_relaxation_2/IO/ADCIRC.h>
#include <CGAL/Bubble_relaxation_2/IO/MSH.h>
#include <CGAL/Bubble_relaxation_2/IO/VTU.h>
#include <CGAL/Bubble_relaxation_2/IO/triangle.h>
#include <CGAL/Mesh_arrays_2.h>

#include <set>
#include <string>
#include <vector>

inline const std::vector<std::string>& mesh_endings()
{
  static const std::vector<std::string> endings{".vtu", ".msh", ".msh2", ".2dm", ".14",
                                                ".grd", ".gr3", ".node", ".ele", ".edge"};
  return endings;
}

inline bool is_of_triangle(const std::string& name)
{
  return extension(name) == ".node" || extension(name) == ".ele" || extension(name) == ".edge";
}

inline bool is_of_adcirc(const std::string& name)
{
  return extension(name) == ".14" || extension(name) == ".grd" || extension(name) == ".gr3";
}

/// whether markers and regions have names there
inline bool has_names(const std::string& name) { return extension(name) == ".msh" || extension(name) == ".msh2"; }

/// the files that a mesh is written to: Triangle's are several
inline std::vector<std::string> mesh_files(const std::string& name)
{
  return is_of_triangle(name) ? CGAL::IO::triangle_files(name) : std::vector<std::string>{name};
}

/// Writes a mesh in the format that the ending of the name tells.
/// \param open the markers of open boundaries
/// \throws std::runtime_error with the name and the reason
inline void write_mesh_file(const std::string& name, const CGAL::Mesh_arrays_2& mesh, const std::set<int>& open)
{
  const std::string ending = extension(name);
  if (is_of_triangle(name))
    CGAL::IO::write_triangle_files(name, mesh);
  else if (is_of_adcirc(name))
    CGAL::IO::write_ADCIRC(name, mesh, open);
  else if (ending == ".msh")
    CGAL::IO::write_MSH(name, mesh);
  else if (ending == ".msh2")
    CGAL::IO::write_MSH2(name, mesh);
  else if (ending == ".2dm")
    CGAL::IO::write_2DM(name, mesh);
  else
    CGAL::IO::write_VTU(name, mesh);
}

#endif // BUBBLE_RELAXATION_2_DEMO_MESH_FILE_H
