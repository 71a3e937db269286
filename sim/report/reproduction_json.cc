#include <cmath>

#include "controller/geometry/pose.h"
#include "sim/report/reproduction_text.h"

namespace dockyard {
namespace {

Json Pair(double low, double high) { return Json::array({low, high}); }
Json Pair(const CountInterval& counts) { return Json::array({counts.low, counts.high}); }
Json OrNull(double value) { return std::isnan(value) ? Json() : Json(value); }
Json PaperJson(const std::optional<PublishedCount>& paper) {
  if (!paper) return nullptr;
  return {{"count", paper->count}, {"runs", paper->runs}};
}

Json RowJson(const RowFinding& each) {
  const Interval interval = ClopperPearson(each.successes, each.runs);
  Json json{{"name", each.row->name},
            {"paper", PaperJson(each.row->paper)},
            {"count", each.successes},
            {"runs", each.runs},
            {"interval95", Pair(interval.low, interval.high)},
            {"judged", each.counts}};
  if (each.strict) json["strict_count"] = each.strict->successes;
  if (!each.row->says.empty()) json["says"] = each.row->says;
  if (!each.row->paper) return json;
  json["comparable"] = each.comparable();
  if (!each.comparable()) return json;
  json["predicted95"] = Pair(each.at_95);
  json["p"] = each.p;
  json["confidence"] = each.confidence;
  json["predicted"] = Pair(each.judged_at);
  json["inside"] = each.inside();
  if (each.strict) {
    json["strict_predicted95"] = Pair(each.strict->at_95);
    json["strict_p"] = each.strict->p;
  }
  return json;
}

Json FailureJson(const FailureFinding& each) {
  Json json{{"name", each.name},    {"paper", PaperJson(each.paper)},
            {"says", each.says},    {"count", each.count},
            {"runs", each.runs},    {"predicted95", each.at_95 ? Pair(*each.at_95) : Json()},
            {"judged", each.counts}};
  if (!each.comparable()) return json;
  json["p"] = each.p;
  json["confidence"] = each.confidence;
  json["predicted"] = Pair(each.judged_at);
  json["inside"] = each.inside();
  return json;
}

Json ErrorJson(const ErrorFinding& each) {
  return {{"at_m", each.paper.at_m},
          {"paper_r_m", OrNull(each.paper.r_m)},
          {"paper_heading_deg", OrNull(Degrees(each.paper.heading_rad))},
          {"sightings", each.sightings},
          {"runs", each.runs},
          {"wrong", each.wrong},
          {"mean_r_m", OrNull(each.mean_r_m)},
          {"median_r_m", OrNull(each.median_r_m)},
          {"mean_place_m", OrNull(each.mean_place_m)},
          {"median_place_m", OrNull(each.median_place_m)},
          {"mean_heading_deg", OrNull(Degrees(each.mean_heading_rad))},
          {"median_heading_deg", OrNull(Degrees(each.median_heading_rad))}};
}

Json MeasureJson(const MeasureFinding& each) {
  Json json{{"name", each.measure->name},
            {"campaign", each.measure->campaign.text},
            {"measure", each.measure->measure.text},
            {"unit", each.unit},
            {"paper",
             std::isnan(each.measure->low) ? Json() : Pair(each.measure->low, each.measure->high)},
            {"simulated", each.simulated},
            {"judged", each.measure->judged},
            {"runs", each.runs}};
  if (each.measure->judged) json["inside"] = each.inside();
  if (each.runs == 0) return json;
  json["mean"] = each.mean;
  json["median"] = each.median;
  json["p10"] = each.low;
  json["p90"] = each.high;
  return json;
}

}  // namespace

Json ReproductionJson(const ReproductionFinding& found) {
  Json json{{"reproduction", found.published->name},
            {"source", found.published->source},
            {"verdict", NameOf(found.verdict)},
            {"replications", found.replications},
            {"runs", found.runs},
            {"rows", Json::array()},
            {"failures", Json::array()},
            {"sightings", Json::array()},
            {"measures", Json::array()}};
  for (const RowFinding& each : found.rows) json["rows"].push_back(RowJson(each));
  for (const FailureFinding& each : found.failures) json["failures"].push_back(FailureJson(each));
  for (const ErrorFinding& each : found.errors) json["sightings"].push_back(ErrorJson(each));
  for (const MeasureFinding& each : found.measures) json["measures"].push_back(MeasureJson(each));
  return json;
}

}  // namespace dockyard
