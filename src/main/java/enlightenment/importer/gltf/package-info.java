/** glTF 2.0: models and scenes in {@code .gltf} files with their buffers and pictures, and in {@code .glb} files. */
package enlightenment.importer.gltf;
