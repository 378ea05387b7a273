#include "solver/burning/front_motion.hpp"

#include <cmath>

#include "solver/burning/surface_motion.hpp"

namespace crawford {

namespace {

/// A node between two materials burns with the mean of their rates: first order, and too slow where
/// the faster side should lead.
class MeanFront : public FrontMotion {
public:
    MeanFront(const Grid& grid, const MaterialMap& materials, const BurningLaw& law)
        : grid_(grid), materials_(materials), law_(law) {}

    SurfaceField burn_rate(const NodeField& temperature) const override {
        return law_.burn_rate(grid_, materials_, temperature);
    }
    SurfaceField rate(const BurningSurface& surface, double) const override {
        return surface_rate(grid_, surface.height, burn_rate(surface.temperature),
                            surface.material_velocity);
    }
    double mean_burn_rate(const SurfaceField& height, const NodeField& temperature) const override {
        return crawford::mean_burn_rate(grid_, height, burn_rate(temperature));
    }

private:
    const Grid& grid_;
    const MaterialMap& materials_;
    const BurningLaw& law_;
};

/// Each side of an interface burns as itself, and where they meet the side that leads rules.
class FasterSideFront : public FrontMotion {
public:
    FasterSideFront(const Grid& grid, const MaterialMap& materials, const BurningLaw& law)
        : grid_(grid), materials_(materials), law_(law) {}

    SurfaceField burn_rate(const NodeField& temperature) const override {
        return faster_rate(grid_, materials_.surface_pieces(), rates(temperature));
    }
    SurfaceField rate(const BurningSurface& surface, double dt) const override {
        return surface_rate(grid_, surface.height, materials_.surface_pieces(),
                            rates(surface.temperature), surface.material_velocity, dt);
    }
    double mean_burn_rate(const SurfaceField& height, const NodeField& temperature) const override {
        return mean_over_pieces(grid_, height, materials_.surface_pieces(), rates(temperature));
    }

private:
    RateOfMaterial rates(const NodeField& temperature) const {
        return [&, this](double fraction, const SurfacePlace& at) {
            if (temperature.empty()) return law_.burn_rate(materials_, fraction, 0.0);
            const int top = grid_.rows();
            return law_.burn_rate(materials_, fraction,
                                  (1.0 - at.of_right) * temperature(at.left, top) +
                                      at.of_right * temperature(at.right, top));
        };
    }

    const Grid& grid_;
    const MaterialMap& materials_;
    const BurningLaw& law_;
};

}  // namespace

std::unique_ptr<FrontMotion> front_motion(Front front, const Grid& grid,
                                          const MaterialMap& materials, const BurningLaw& law) {
    if (front == Front::mean_of_materials) return std::make_unique<MeanFront>(grid, materials, law);
    return std::make_unique<FasterSideFront>(grid, materials, law);
}

}  // namespace crawford
