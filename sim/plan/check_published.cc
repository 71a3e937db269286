#include <algorithm>

#include "models/read/config_error.h"
#include "models/read/near_names.h"
#include "sim/plan/published.h"

namespace dockyard {
namespace {

void Require(const PublishedName& name, const std::vector<std::string>& known,
             const std::string& what) {
  if (std::find(known.begin(), known.end(), name.text) != known.end()) return;
  const std::string nearest = NearestName(name.text, known);
  throw ConfigError(name.place.Text() + ": " + name.path + ": expected " + what + ", found '" +
                    name.text + "'" + (nearest.empty() ? "" : "; nearest is '" + nearest + "'"));
}

void RequireLabels(const std::vector<LabelFilter>& where, const CampaignNames& names) {
  for (const LabelFilter& filter : where) {
    Require(filter.label, names.labels, "a label of the campaign");
  }
}

void RequireAll(const std::vector<PublishedName>& given, const std::vector<std::string>& known,
                const std::string& what) {
  for (const PublishedName& name : given) Require(name, known, what);
}

}  // namespace

void CheckPublished(const Published& published, const std::vector<CampaignNames>& campaigns) {
  const CampaignNames& first = campaigns.at(0);
  RequireAll(published.counted, first.outcomes, "an outcome of the system");
  RequireAll(published.strict, first.outcomes, "an outcome of the system");
  for (const FailureClass& failure : published.failures) {
    RequireLabels(failure.where, first);
    for (const FailureCase& each : failure.cases) {
      RequireAll(each.outcomes, first.outcomes, "an outcome of the system");
      for (const ColumnFilter& filter : each.where) {
        Require(filter.column, first.measures, "a column of results.csv");
      }
    }
  }
  std::vector<std::string> names;
  for (const PublishedCampaign& each : published.campaigns) names.push_back(each.name);
  const auto of = [&](const PublishedName& name) -> const CampaignNames& {
    Require(name, names, "the name of a campaign of this file");
    const auto at = std::find(names.begin(), names.end(), name.text);
    return campaigns.at(static_cast<std::size_t>(at - names.begin()));
  };
  for (const PublishedRow& row : published.rows) {
    const CampaignNames& its = row.campaign ? of(*row.campaign) : first;
    RequireLabels(row.where, its);
    RequireAll(row.outcomes, its.outcomes, "an outcome of the system");
  }
  for (const PublishedMeasure& measure : published.measures) {
    const CampaignNames& its = of(measure.campaign);
    Require(measure.measure, its.measures, "a column of results.csv");
    RequireLabels(measure.where, its);
  }
  for (const PublishedFigure& figure : published.figures) {
    RequireLabels(figure.where, first);
    RequireAll(figure.channels, first.channels, "a channel of the history");
    if (figure.least_measure) {
      Require(*figure.least_measure, first.measures, "a column of results.csv");
    }
  }
}

}  // namespace dockyard
