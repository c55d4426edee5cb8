/** Next-event estimation: light that reaches a vertex straight from lights and surroundings. */
package enlightenment.transport.direct;
