/**
 * The planning of a render before its first tile. {@link enlightenment.plan.Planner} turns a budget (samples, error, time) into a
 * {@link enlightenment.plan.RenderPlan}, by trials on some blocks of the picture with random numbers of their own;
 * {@link enlightenment.plan.Integrators} makes the integrators of a plan; {@link enlightenment.plan.Rounds} decides whether the finished
 * picture is as exact as was asked. Internal.
 */
package enlightenment.plan;
