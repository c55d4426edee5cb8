/** Jobs as bytes that are equal wherever they are made: scene, settings and plan, tiles, and files of parts. */
package enlightenment.net.job;
