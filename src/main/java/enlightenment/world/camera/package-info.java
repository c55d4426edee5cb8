/** Cameras as rendering reads them: the ray of a film position, the film position of a point, and the frustum of a tile. */
package enlightenment.world.camera;
