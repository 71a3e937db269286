# Reads every #include of the tree and fails where a room reaches into one that it must not know.
# An include path keeps honest code out; this catches "../" and system-wide headers too.
# Run as a step of the build and as a test: cmake -DROOT=<source folder> -P firewall.cmake
set(contract "controller/base/|controller/geometry/|controller/io/|Eigen/")

# folder | what it may include, as a regular expression on the path between the quotes or brackets
set(rules
  "controller/base|${contract}"
  "controller/geometry|${contract}"
  "controller/io|${contract}"
  "controller/vision|${contract}|controller/vision/|opencv2/"
  "controller/motion|${contract}|controller/motion/"
  "controller/docking|${contract}|controller/vision/locate.h|controller/motion/|controller/docking/"
  "models|${contract}|models/|yaml-cpp/|assimp/|console_bridge/|urdf_parser/|urdf_model/|tinyxml2?.h|sys/|unistd.h|fcntl.h"
  "render|${contract}|render/|GL/|EGL/|dlfcn.h"
  "sim/base|sim/base/"
  "sim/soil|${contract}|models/|sim/base/|sim/soil/"
  "sim/physics|${contract}|models/|sim/base/|sim/soil/|sim/physics/|bt|Bullet|LinearMath/"
  "sim/log|${contract}|models/|sim/base/|sim/log/|sim/run/record.h|nlohmann/|opencv2/|sys/|unistd.h|fcntl.h"
  "sim/run|${contract}|models/|render/|sim/(base|soil|physics|log|run)/|nlohmann/|opencv2/|sys/|unistd.h"
  "sim/campaign|${contract}|models/|sim/(base|log|campaign)/|sim/run/(record|loop).h|nlohmann/|sqlite3.h|sys/|unistd.h|fcntl.h|poll.h"
  "sim/study|${contract}|models/|sim/(base|log|campaign|study)/|sim/run/(record|loop).h"
  "sim/app|${contract}|models/|controller/docking/axel.h|controller/vision/(locate|point_pose|pose_refine).h|sim/|CLI/|opencv2/|nlohmann/|sys/|unistd.h|fcntl.h")

set(errors "")
set(files_read 0)
foreach(rule IN LISTS rules)
  string(REGEX MATCH "^[^|]+" folder "${rule}")
  string(LENGTH "${folder}|" skip)
  string(SUBSTRING "${rule}" ${skip} -1 allowed)
  file(GLOB files "${ROOT}/${folder}/*.h" "${ROOT}/${folder}/*.cc")
  foreach(file IN LISTS files)
    math(EXPR files_read "${files_read} + 1")
    file(STRINGS "${file}" includes REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS includes)
      string(REGEX REPLACE "^[^<\"]*[<\"]([^>\"]*)[>\"].*$" "\\1" path "${line}")
      if(path MATCHES "\\.\\.")
        list(APPEND errors "${file}: includes \"${path}\": no way upwards")
      elseif(path MATCHES "^(${allowed})")
      elseif(path MATCHES "[/.]")
        if(NOT path MATCHES "^(dlfcn|poll|time|signal|errno|math|stdint)\\.h$")
          list(APPEND errors "${file}: includes \"${path}\", which ${folder}/ must not know")
        endif()
      endif()
    endforeach()
  endforeach()
endforeach()

if(files_read EQUAL 0)
  message(FATAL_ERROR "firewall: no source files found under '${ROOT}'")
endif()
if(errors)
  list(JOIN errors "\n  " text)
  message(FATAL_ERROR "firewall: rooms that reach where they must not:\n  ${text}")
endif()
message(STATUS "firewall: ${files_read} files keep to their rooms")
