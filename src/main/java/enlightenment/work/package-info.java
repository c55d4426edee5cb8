/**
 * How a render is carried out, whatever it renders: the threads that share numbered pieces of work, what ends it early, the
 * time and memory that its phases take. Internal.
 */
package enlightenment.work;
