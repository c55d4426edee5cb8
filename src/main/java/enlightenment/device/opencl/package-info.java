/** Devices that are programmed in OpenCL: the only package that knows the library which binds it. Internal. */
package enlightenment.device.opencl;
