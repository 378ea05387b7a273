/// The picture of a judged table.
#pragma once

#include <filesystem>
#include <vector>

#include "reports/order_judgement.hpp"

namespace crawford::reports {

/// Errors, and of values how far neighbouring grids differ, against h on logarithmic axes, with the
/// expected slope: one SVG, whole or absent.
/// \throws FigureFailed; InputError if the file is none that ends in .svg or cannot be written, or
/// if no column has anything to draw.
void draw_orders(const std::filesystem::path& file, const OrderTable& table,
                 const std::vector<JudgedColumn>& columns);

}  // namespace crawford::reports
