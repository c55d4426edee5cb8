/** The arrays of triangle meshes. */
package enlightenment.mesh.data;
