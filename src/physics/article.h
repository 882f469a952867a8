// The article's method: Paul Firth, "The physics of rolling" (wildbunny, 2012), faithfully, once a step.
//
// Where a ball of radius r touches a surface of unit normal n it keeps the velocity t = v - (v.n) n. The signed length
// of what it keeps is L = v ^ n, and the roll is theta = L / r: with counter-clockwise angles the spin is -(v ^ n) / r,
// and over a step the ball turns by the arc that its centre runs through, L dt / r.
//
// Why this is exact for one kind of ball: friction that forbids slip changes v and the rim speed together, and how much
// of the change falls on v is k / (1 + k), with k = I / (m r^2). Let all the mass sit at the hub: k = 0, turning costs
// nothing, so full grip takes nothing from v and the spin follows at once. What is left of a contact is that it stops
// the velocity along n; the motion is a frictionless slide and the rotation a decoration upon it (physics.md 2.1). A
// ball with mass at its rim has to pay for its spin out of v, and this rule lets it spin for nothing: a disc that comes
// down without spin leaves with up to half as much energy again, and on a slope it gains g sin a in place of two thirds
// of it.
//
// The article names its limits, and they are kept: full grip, no bounce, one circle (balls do not meet each other),
// dead stop at a wall. Contact is looked for at the end of a step only, on the side where the centre is then: a ball
// that crosses a line by more than its radius within one step comes out on the other side. That is why its readers'
// ball falls through the floor.
#pragma once

#include "physics/world/world.h"

namespace physics {

// One step of one ball over `dt` seconds, touching whatever terrain it comes into.
struct ArticleStep {
    State state;
    Contact contact;
};
ArticleStep article_step(Scene const& scene, Forces const& forces, int ball, State const& state, double dt);

// Once a step.
struct Article {
    double rate = 240;  // steps/s
};

void advance_with(Article const& method, Scene const& scene, World& world, double until, History& history);

}  // namespace physics
