# The rooms and what each may include: folder | its job | a regular expression on the path between the
# quotes or brackets. <system> stands for one of `systems`: the rooms of a system know the generic rooms
# and their own system, never another. In a line whose folder names no system it stands for any of them.
# A single file may have a line of its own, which holds instead of its folder's.
# The standard library is open to all by its C++ names (<cmath>, not math.h), the operating system to those
# that name it. A folder with sources and without a line here is an error. No semicolon in a line: CMake ends an item there.
include(${CMAKE_CURRENT_LIST_DIR}/systems.cmake)

set(contract "controller/(base|geometry|io)/|Eigen/")
set(os "sys/|unistd.h|fcntl.h|poll.h|signal.h")
set(models "${contract}|models/(parts|read)/")
set(low "sim/(base|mcap|images|draws|jobs|scenario|plan|soil|rigid|cable|drives|vehicles|log|bridge|statistics|report|plant|run)/")

set(rooms
  "controller/base|checks and results|${contract}"
  "controller/geometry|poses, cameras, lenses, images|${contract}"
  "controller/io|what any robot senses, can be told and believes|${contract}"
  "controller/imaging|asking cameras for images, and where the robot was when they were exposed|${contract}|controller/imaging/"
  "controller/vision|poses from known points, of one camera or two, outlines and colours in images|${contract}|controller/vision/[a-z0-9_]*[.]h|opencv2/"
  "controller/vision/board|images in, pose of a board of fiducials out|${contract}|controller/vision/([a-z0-9_]*[.]h|board/)|opencv2/"
  "controller/vision/tags|square tags of AprilTag and ArUco families: their codes, and their pose from an image|${contract}|controller/vision/([a-z0-9_]*[.]h|tags/)|opencv2/|apriltag/"
  "controller/vision/points|named points in, pose of any body out|${contract}|controller/vision/"
  "controller/stereo|a stereo pair in, distances out|${contract}|controller/stereo/|opencv2/"
  "controller/tracking|a target followed from one map of heights to the next|${contract}|controller/(stereo|tracking)/"
  "controller/motion|arcs and following them|${contract}|controller/motion/"
  "controller/<system>/nominal|the nominal parameters that a controller is told|${contract}|controller/<system>/nominal/"
  "controller/<system>|a system's controllers|${contract}|controller/(imaging|vision|motion|stereo|tracking|<system>)/"
  "models/parts|what things are: links, motors, wheels, cameras, soil|${contract}|models/parts/"
  "models/read|files in: YAML, CSV, URDF, meshes, and parts|${models}|controller/vision/tags/|yaml-cpp/|assimp/|bullet/HACD/|nlohmann/|console_bridge/|urdf_parser/|urdf_model/|tinyxml2?.h|${os}"
  "models/<system>|a system's robot and target: structs, readers, data|${models}|models/<system>/|controller/<system>/nominal/"
  "render|a scene in, images out, without physics|${contract}|render/|GL/|EGL/|dlfcn.h"
  "sim/base|random streams, normal numbers, hashes, files, text, JSON, what this computer is|${contract}|sim/base/|nlohmann/|opencv2/core/version.hpp|zlib.h|openssl/|${os}"
  "sim/mcap|MCAP files, and messages in CDR in them|controller/base/|sim/(base|mcap)/|zstd.h|lz4frame.h"
  "sim/images|image files: PNG, JPEG, PGM, PPM, WebP and TIFF in, PNG out|${contract}|sim/(base|images)/|png.h|zlib.h|jpeglib.h|tiffio.h|webp/"
  "sim/draws|values of dispersed numbers: distributions, designs, correlation|${contract}|sim/(base|draws)/|boost/random/"
  "sim/jobs|work in processes of its own|controller/base/|sim/(base|jobs)/|${os}"
  "sim/scenario|what one run is: a scenario, its keys and files|${models}|sim/(base|scenario)/"
  "sim/plan|which runs a campaign has, and how each is made|${models}|sim/(base|draws|scenario|plan)/"
  "sim/soil|stress of deformable soil on wheels with paddles, without Bullet|${models}|sim/(base|soil)/"
  "sim/rigid|rigid bodies: trees of links, shapes, contacts and their solver|${models}|sim/(base|soil|rigid)/|bt|Bullet|LinearMath/"
  "sim/cable|a cable with mass over ground and bodies|${models}|sim/(base|soil|rigid|cable)/"
  "sim/drives|motors with gears, encoders, currents, the inertial unit|${models}|sim/(base|rigid|drives)/"
  "sim/vehicles|wheels, belts, arms and masts on soil, and the stones that they meet|${models}|sim/(base|soil|rigid|drives|vehicles)/"
  "sim/log|files of one run: log, history, result row|${contract}|sim/(base|mcap|images|log)/|nlohmann/"
  "sim/bridge|a controller in another process|${contract}|sim/(base|log|bridge)/|linux/|${os}"
  "sim/statistics|numbers in, numbers out: intervals, acceptance, sequential tests, comparisons, rank correlation|${contract}|sim/statistics/|boost/math/"
  "sim/report|results in figures and words|${contract}|sim/(base|plan|log|statistics|report)/"
  "sim/plant|what the worlds of all systems share: cameras as built, light, ground, scenery, meshes, models read once, nominal numbers|${models}|render/|sim/(base|images|scenario|soil|rigid|drives|vehicles|plant)/|unistd.h"
  "sim/run|one run in closed loop, for any system|${models}|render/|sim/(base|scenario|log|bridge|plant|run)/|unistd.h"
  "sim/paths|planned paths: candidates, wheels along them, drawings, a run to watch|${contract}|controller/motion/|render/|sim/(base|log|report|run|paths)/"
  "sim/page|results as one HTML file|${contract}|models/read/|render/|sim/(base|images|plan|log|statistics|report|run|spectator|page)/|zlib.h"
  "sim/spectator|a logged run in pictures: from outside, and what its cameras saw|${contract}|models/read/|render/|sim/(base|images|log|run|spectator)/|opencv2/"
  "sim/<system>|a system's world, cameras, judge and plots|${models}|models/<system>/|controller/<system>/nominal/|controller/motion/|render/|${low}|sim/<system>/|bt|Bullet|LinearMath/|nlohmann/"
  "sim/campaign|many runs: workers, shards, merging, progress|${contract}|models/read/|${low}|sim/campaign/|nlohmann/|sqlite3.h|${os}"
  "sim/app/systems.cc|the list of systems with their controllers|${contract}|sim/(run|app)/|controller/<system>/|sim/<system>/|sim/app/<system>/"
  "sim/app/<system>|a system's own commands|${models}|models/<system>/|controller/(vision|<system>)/|sim/(base|images|scenario|run)/|sim/<system>/|sim/app/<system>/|CLI/"
  "sim/app|the program: the command line|${models}|controller/(vision|motion|stereo)/|${low}|sim/(campaign|page|paths|spectator|app)/|CLI/|opencv2/|nlohmann/|${os}")
