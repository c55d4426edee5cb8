/**
 * The state of a path from vertex to vertex: its throughput, its scattering events and the radiance it has gathered; the power heuristic
 * and Russian roulette.
 */
package enlightenment.transport.state;
