/**
 * Checks of values that come from outside, shared by the constructors of descriptions and settings. A failed check throws
 * {@link enlightenment.math.InvalidValueException}, which names the value's key.
 */
package enlightenment.check;
