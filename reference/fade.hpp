/// A smooth function from one to zero, with its derivatives.
#pragma once

#include <Eigen/Core>

namespace crawford::reference {

/// A function of the distance r to the origin: 1 up to r = `whole`, 0 from r = `gone` on, between
/// them a polynomial with three continuous derivatives.
class Fade {
public:
    /// \throws std::invalid_argument naming the parameter, unless 0 < whole < gone.
    Fade(double whole, double gone);

    struct Value {
        double value;
        Eigen::Vector2d gradient;
        Eigen::Matrix2d hessian;
    };
    Value at(double x, double y) const;

private:
    double whole_, gone_;
};

}  // namespace crawford::reference
