# dockyard_apriltag(): the imported target dockyard_april::tag, AprilTag 3 (Debian's libapriltag-dev). What is
# not found is listed in `dockyard_apriltag_missing`, for the caller to tell.
# The build uses it, and the installed package as well.
function(dockyard_apriltag)
  set(missing "")
  find_path(DOCKYARD_APRILTAG_INCLUDE apriltag/apriltag.h)
  find_library(DOCKYARD_APRILTAG apriltag)
  if(NOT DOCKYARD_APRILTAG_INCLUDE OR NOT DOCKYARD_APRILTAG)
    set(missing libapriltag-dev)
  elseif(NOT TARGET dockyard_april::tag)
    add_library(dockyard_april::tag UNKNOWN IMPORTED GLOBAL)
    set_target_properties(dockyard_april::tag PROPERTIES
      IMPORTED_LOCATION ${DOCKYARD_APRILTAG}
      INTERFACE_INCLUDE_DIRECTORIES "${DOCKYARD_APRILTAG_INCLUDE};${DOCKYARD_APRILTAG_INCLUDE}/apriltag")
  endif()
  set(dockyard_apriltag_missing "${missing}" PARENT_SCOPE)
endfunction()
