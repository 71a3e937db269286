// Which pixels of a patch show the face itself.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

namespace dockyard {

/// The face's own greys, by those of the patch's inner part. What is far brighter or darker is
/// another surface: sky and sunlit ground behind a boulder's edge would outweigh its stains. About
/// it nothing counts, as greys mix there: once a shadow falls on that ground the mixed ones change.
/// @param greys           CV_32F, smoothed, square
/// @param on_face         CV_8U, as large: 0 where a pixel shows no face
/// @param least_contrast  grey, one sigma over the inner part; none where it is less
/// @return                CV_8U, 0 where a pixel does not count
std::optional<cv::Mat> OwnGreys(const cv::Mat& greys, const cv::Mat& on_face,
                                double least_contrast);

}  // namespace dockyard
