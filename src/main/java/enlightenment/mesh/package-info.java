/** Triangle meshes: flat arrays of shared vertices, their normals, and the files they come from. */
package enlightenment.mesh;
