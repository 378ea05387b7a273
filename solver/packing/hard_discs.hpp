/// Event-driven motion of hard discs that grow: the machine behind random packs.
///
/// Between collisions the discs fly straight, so time leaps from one collision to the next and
/// nothing is integrated (Lubachevsky and Stillinger, J. Stat. Phys. 60, 1990, 561). The box is
/// periodic both ways; a disc may meet several images of another.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "solver/packing/contact.hpp"
#include "solver/packing/event_queue.hpp"

namespace crawford {

struct Box {
    double width, height;  ///< periods in x and y
};

struct HardDisc {
    double x, y;    ///< centre
    double u, v;    ///< velocity
    double radius;  ///< at size 1
    double mass;
};

/// All radii are `size` times those of the discs. Units are the caller's.
///
/// The result is the same on any machine: only operations that IEEE 754 rounds correctly are used,
/// in a fixed order, and of collisions at the same time the first in the list is taken. The room is
/// compiled with -ffp-contract=off, for a fused multiply-add rounds once instead of twice.
class HardDiscs {
public:
    /// At any size that they reach, diameters must be less than width and height.
    HardDiscs(const Box&, std::vector<HardDisc>, double size);

    const std::vector<HardDisc>& discs() const { return discs_; }
    double size() const { return size_; }
    double energy() const;  ///< kinetic
    /// Scales all velocities. Discs at rest stay so.
    void set_energy(double energy);

    /// Moves on for `duration`, which may be infinite where nothing grows, or until there have been
    /// `most` collisions, with d(size)/dt = `growth`; returns the number of collisions. A collision
    /// conserves momentum, and energy too where nothing grows; growth does work.
    long advance(double growth, double duration, long most = std::numeric_limits<long>::max());

private:
    /// A disc and an image of another one that it may meet before the list is made anew.
    struct Pair {
        std::size_t first, second;
        double shift_x, shift_y;  ///< from the second disc to its image
    };

    void list_pairs(double largest);
    void list_images(std::size_t first, std::size_t second, double reach);
    void predict_all();
    void predict(std::size_t disc);
    long run(double end, long most);
    void drift(double duration);
    void collide(const Pair&);
    Approach approach(const Pair&) const;
    double time_to_escape(std::size_t disc) const;

    Box box_;
    std::vector<HardDisc> discs_;
    double size_;
    double growth_ = 0.0;
    double margin_;                              ///< how far a disc may go before a new list
    double clock_ = 0.0;                         ///< time since the list was made
    std::vector<HardDisc> start_;                ///< the discs when it was made
    std::vector<Pair> pairs_;                    ///< the list
    std::vector<std::vector<std::size_t>> met_;  ///< those of each disc
    EventQueue events_;                          ///< contact of each pair, then escape of each disc
};

}  // namespace crawford
