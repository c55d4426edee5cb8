/**
 * What a path carries from vertex to vertex: its throughput, its history and the light it has gathered; the power heuristic and
 * Russian roulette.
 */
package enlightenment.transport.state;
