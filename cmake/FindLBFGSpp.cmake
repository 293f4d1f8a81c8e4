# LBFGSpp, L-BFGS as a header over Eigen: target LBFGSpp::LBFGSpp.
find_path(LBFGSPP_INCLUDE_DIR LBFGS.h)
mark_as_advanced(LBFGSPP_INCLUDE_DIR)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LBFGSpp REQUIRED_VARS LBFGSPP_INCLUDE_DIR)
if(LBFGSpp_FOUND AND NOT TARGET LBFGSpp::LBFGSpp)
  add_library(LBFGSpp::LBFGSpp INTERFACE IMPORTED)
  set_target_properties(LBFGSpp::LBFGSpp PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${LBFGSPP_INCLUDE_DIR}")
endif()
