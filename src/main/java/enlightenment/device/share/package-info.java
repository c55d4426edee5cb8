/** The part of a render that a device has. */
package enlightenment.device.share;
