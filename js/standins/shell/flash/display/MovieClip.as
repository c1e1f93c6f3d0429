package flash.display
{
    /** One frame. */
    public dynamic class MovieClip extends Sprite
    {
    }
}
