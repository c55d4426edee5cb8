/** Rays and triangle meshes: the hierarchy of a mesh's triangles, and the closest of them that a ray meets. */
package enlightenment.mesh.tree;
