/**
 * The methods: which samples are taken, and how they become pixels. Each implements {@link enlightenment.method.TileIntegrator}; their
 * names are in {@link enlightenment.scene.Method}. Internal.
 */
package enlightenment.method;
