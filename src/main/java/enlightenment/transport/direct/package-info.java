/** Next-event estimation: direct light of lamps and surroundings at a vertex. */
package enlightenment.transport.direct;
