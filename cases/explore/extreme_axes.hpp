/// Axes that several maps of the extremes share.
#pragma once

#include <string>
#include <vector>

#include "cases/explore/extreme_map.hpp"

namespace crawford::extreme {

ExtremeAxis flux(std::vector<double> over_the_paper);
ExtremeAxis step(std::vector<double> us);
ExtremeAxis rows(std::vector<double> cells);
ExtremeAxis columns(std::vector<double> cells);
ExtremeAxis depth(std::vector<double> um);
ExtremeAxis clustering(std::vector<double> exponents);
ExtremeAxis pressure(std::vector<double> megapascal);
/// A property of the last material (the binder of two), over the paper's.
ExtremeAxis property(double Material::*member, const std::string& key, const std::string& label,
                     std::vector<double> over_the_paper);

/// Scheme, coupling, element and the beta of the stress work: every way to couple.
ExtremeAxis couplings();

}  // namespace crawford::extreme
