/**
 * The methods: which samples are taken, and how they become pixels. Each is an {@link enlightenment.method.Integrator} of one of two
 * kinds; their names are in {@link enlightenment.scene.Method}. Internal.
 */
package enlightenment.method;
