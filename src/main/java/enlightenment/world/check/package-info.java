/** Checks of a scene before it is rendered: problems that end a render, and hints. */
package enlightenment.world.check;
