/**
 * The methods, which choose samples and turn them into pixels. Each is an {@link enlightenment.method.Integrator} of one of two kinds;
 * their names are in {@link enlightenment.scene.Method}. Internal.
 */
package enlightenment.method;
