/** The viewpoint of a view: motions of cameras, rounded so that they can be written as short decimals. */
package enlightenment.view.camera;
