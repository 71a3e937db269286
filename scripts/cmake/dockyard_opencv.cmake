# dockyard_opencv(NAME...): the imported targets dockyard_cv::NAME. Debian's component packages of
# OpenCV bring no CMake configuration, so header and libraries are looked for by name. Those that are
# not found are listed in `dockyard_opencv_missing`, for the caller to tell.
# The build uses it, and the installed package as well.
function(dockyard_opencv)
  set(missing "")
  find_path(DOCKYARD_OPENCV_INCLUDE opencv2/core.hpp PATH_SUFFIXES opencv4)
  if(NOT DOCKYARD_OPENCV_INCLUDE)
    list(APPEND missing opencv2/core.hpp)
  endif()
  foreach(component IN LISTS ARGN)
    find_library(DOCKYARD_OPENCV_${component} opencv_${component})
    if(NOT DOCKYARD_OPENCV_${component})
      list(APPEND missing libopencv_${component})
    elseif(NOT TARGET dockyard_cv::${component})
      add_library(dockyard_cv::${component} UNKNOWN IMPORTED GLOBAL)
      set_target_properties(dockyard_cv::${component} PROPERTIES
        IMPORTED_LOCATION ${DOCKYARD_OPENCV_${component}}
        INTERFACE_INCLUDE_DIRECTORIES "${DOCKYARD_OPENCV_INCLUDE}")
    endif()
  endforeach()
  set(dockyard_opencv_missing "${missing}" PARENT_SCOPE)
endfunction()
