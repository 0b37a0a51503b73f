// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The named parameters that the package adds to CGAL's. No include guard: the file is included several
// times with different macros, as CGAL's own list is. When the package moves into CGAL these lines move
// into that list.

CGAL_add_named_parameter(force_coefficient_t, force_coefficient, force_coefficient)
CGAL_add_named_parameter(mass_t, mass, mass)
CGAL_add_named_parameter(damping_t, damping, damping)
CGAL_add_named_parameter(time_step_t, time_step, time_step)
CGAL_add_named_parameter(integrator_t, integrator, integrator)
CGAL_add_named_parameter(number_of_rounds_t, number_of_rounds, number_of_rounds)
CGAL_add_named_parameter(renewal_interval_t, renewal_interval, renewal_interval)
CGAL_add_named_parameter(initial_placement_t, initial_placement, initial_placement)
CGAL_add_named_parameter(population_control_t, population_control, population_control)
CGAL_add_named_parameter(defect_treatment_t, defect_treatment, defect_treatment)
CGAL_add_named_parameter(limit_by_outline_t, limit_by_outline, limit_by_outline)
CGAL_add_named_parameter(size_growth_t, size_growth, size_growth)
CGAL_add_named_parameter(minimum_angle_t, minimum_angle, minimum_angle)
CGAL_add_named_parameter(edge_marker_t, edge_marker, edge_marker_map)
CGAL_add_named_parameter(face_region_t, face_region, face_region_map)
CGAL_add_named_parameter(elevation_function_t, elevation_function, elevation_function)
CGAL_add_named_parameter(displacement_tolerance_t, displacement_tolerance, displacement_tolerance)
CGAL_add_named_parameter(maximum_number_of_bubbles_t, maximum_number_of_bubbles, maximum_number_of_bubbles)
CGAL_add_named_parameter(maximum_number_of_vertices_t, maximum_number_of_vertices, maximum_number_of_vertices)
CGAL_add_named_parameter(outline_tolerance_t, outline_tolerance, outline_tolerance)
CGAL_add_named_parameter(relative_outline_tolerance_t, relative_outline_tolerance, relative_outline_tolerance)
CGAL_add_named_parameter(minimum_island_area_t, minimum_island_area, minimum_island_area)
CGAL_add_named_parameter(minimum_gap_t, minimum_gap, minimum_gap)
CGAL_add_named_parameter(corner_angle_t, corner_angle, corner_angle)
CGAL_add_named_parameter(restore_when_stopped_t, restore_when_stopped, restore_when_stopped)
CGAL_add_named_parameter(exchange_interval_t, exchange_interval, exchange_interval)

// of influence domains, moving least squares and the element-free Galerkin method
CGAL_add_named_parameter(influence_search_t, influence_search, influence_search)
CGAL_add_named_parameter(support_radius_t, support_radius, support_radius)
CGAL_add_named_parameter(support_factor_t, support_factor, support_factor)
CGAL_add_named_parameter(mls_basis_t, mls_basis, mls_basis)
CGAL_add_named_parameter(mls_weight_t, mls_weight, mls_weight)
CGAL_add_named_parameter(deficient_support_t, deficient_support, deficient_support)
CGAL_add_named_parameter(maximum_condition_number_t, maximum_condition_number, maximum_condition_number)
CGAL_add_named_parameter(dirichlet_condition_t, dirichlet_condition, dirichlet_condition)
CGAL_add_named_parameter(penalty_factor_t, penalty_factor, penalty_factor)
CGAL_add_named_parameter(nitsche_factor_t, nitsche_factor, nitsche_factor)
CGAL_add_named_parameter(integration_cells_t, integration_cells, integration_cells)
CGAL_add_named_parameter(grid_cells_t, grid_cells, grid_cells)
CGAL_add_named_parameter(number_of_gauss_points_t, number_of_gauss_points, number_of_gauss_points)
CGAL_add_named_parameter(consistent_integration_t, consistent_integration, consistent_integration)
CGAL_add_named_parameter(residual_tolerance_t, residual_tolerance, residual_tolerance)

// of transfers between two triangulations
CGAL_add_named_parameter(transfer_method_t, transfer_method, transfer_method)
CGAL_add_named_parameter(source_faces_t, source_faces, source_faces)
CGAL_add_named_parameter(target_faces_t, target_faces, target_faces)
CGAL_add_named_parameter(source_in_domain_map_t, source_in_domain_map, source_in_domain_map)
CGAL_add_named_parameter(target_in_domain_map_t, target_in_domain_map, target_in_domain_map)
CGAL_add_named_parameter(keep_integral_t, keep_integral, keep_integral)

// parts that are meshed anew
CGAL_add_named_parameter(longest_edge_t, longest_edge, longest_edge)
CGAL_add_named_parameter(shortest_edge_t, shortest_edge, shortest_edge)
CGAL_add_named_parameter(misfit_angle_t, misfit_angle, misfit_angle)
CGAL_add_named_parameter(misfit_quality_t, misfit_quality, misfit_quality)
CGAL_add_named_parameter(number_of_rings_t, number_of_rings, number_of_rings)
CGAL_add_named_parameter(faces_to_check_t, faces_to_check, faces_to_check)

// names that newer versions of CGAL have
#if CGAL_VERSION_NR < 1050600000
CGAL_add_named_parameter(seeds_t, seeds, seeds)
CGAL_add_named_parameter(seeds_are_in_domain_t, seeds_are_in_domain, seeds_are_in_domain)
#endif
#if CGAL_VERSION_NR < 1060000000
CGAL_add_named_parameter(sizing_function_t, sizing_function, sizing_function)
CGAL_add_named_parameter(concurrency_tag_t, concurrency_tag, concurrency_tag)
#endif
