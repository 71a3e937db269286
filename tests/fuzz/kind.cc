#include "fuzz/kind.h"

#include "models/read/config_error.h"
#include "sim/bridge/answer_json.h"
#include "sim/log/frame_codec.h"
#include "sim/log/results.h"

namespace dockyard {

bool ReadOrRefused(const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const ConfigError&) {
    return false;
  } catch (const ResultsError&) {
    return false;
  } catch (const DataError&) {
    return false;
  } catch (const AnswerError&) {  // the run's outcome, controller_error
    return false;
  }
}

std::vector<NamedKind> AllFuzzKinds(const MeshFuzzOptions& options) {
  std::vector<NamedKind> all;
  for (const auto& group :
       {PlanKinds(), ModelKinds(), MeshKinds(options), RecordKinds(), ImageKinds()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

}  // namespace dockyard
