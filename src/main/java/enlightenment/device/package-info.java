/**
 * Camera samples shaded on another device than the processor, to the last bit as the processor shades them. What stands here knows no library
 * and no driver; {@code device.opencl} does. Internal.
 */
package enlightenment.device;
