#include "cases/verify/burning/series.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace crawford {

std::complex<double> swing(std::span<const double> series, double start, double step, double w) {
    const auto count = Eigen::Index(series.size());
    Eigen::MatrixXd model(count, 8);
    Eigen::VectorXd found(count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const double t = start + double(k) * step;
        const double d = double(k) / double(count);
        model.row(k) << std::cos(w * t), -std::sin(w * t), std::cos(2.0 * w * t),
            std::sin(2.0 * w * t), 1.0, d, d * d, d * d * d;
        found[k] = series[size_t(k)];
    }
    const Eigen::VectorXd fit = model.colPivHouseholderQr().solve(found);
    return {fit[0], fit[1]};
}

std::complex<double> swinging_growth(std::span<const double> series, double step, int lag) {
    const auto count = Eigen::Index(series.size()) - 2 * lag;
    Eigen::MatrixXd before(count, 2);
    Eigen::VectorXd next(count);
    for (Eigen::Index k = 0; k < count; ++k) {
        before.row(k) << series[size_t(k + lag)], series[size_t(k)];
        next[k] = series[size_t(k + 2 * lag)];
    }
    const Eigen::VectorXd fit = before.colPivHouseholderQr().solve(next);
    const double factor = std::sqrt(-fit[1]);
    return std::complex<double>(std::log(factor), std::acos(0.5 * fit[0] / factor)) / (lag * step);
}

double plain_growth(std::span<const double> series, double step) {
    const double middle = 0.5 * double(series.size() - 1);
    double moment = 0.0;
    double spread = 0.0;
    for (size_t k = 0; k < series.size(); ++k) {
        const double from_middle = double(k) - middle;
        moment += from_middle * std::log(series[k]);
        spread += from_middle * from_middle;
    }
    return moment / (spread * step);
}

}  // namespace crawford
