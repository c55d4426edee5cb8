/** Where a view looks from: a camera that is turned, moved and written back as text. */
package enlightenment.view.camera;
