/** What is rendered, as bytes that are the same wherever they are made: scene, settings and plan, tiles, and files of parts. */
package enlightenment.net.job;
