/** An interactive view of a scene on a page: progressive rendering, restarted by each change of camera or file. */
package enlightenment.view;
