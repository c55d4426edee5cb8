/**
 * How surfaces scatter light: value, samples and their density for each kind of surface, one class for each. Internal.
 */
package enlightenment.bsdf;
