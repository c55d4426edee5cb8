/** Films of finished frames: files that several pictures are played from. */
package enlightenment.video;
