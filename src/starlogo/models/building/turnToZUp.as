package starlogo.models.building
{

    /**
     * The turn that makes an axis point up along z. If y is up, the file's -z becomes y. If x is up, -y becomes x and -z becomes y. (The
     * COLLADA specification's table for up_axis gives the right and inward axes.)
     *
     * @param upAxis the axis that points up: "x", "y" or "z"
     *
     * @private
     */
    public function turnToZUp(upAxis:String):AffineTransform
    {
        switch (upAxis)
        {
            case "x":
                return new AffineTransform(new <Number>[0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0]);
            case "y":
                return new AffineTransform(new <Number>[1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0]);
            default:
                return new AffineTransform();
        }
    }
}
