package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.fitting.FitSession;
    import starlogo.fitting.Fitter;

    /** Gives every model the same upright capsule, which stands on the model's origin. */
    internal final class OneCapsuleFitter extends Fitter
    {
        private var _radius:Number;
        private var _length:Number;

        /**
         * @param radius of the capsule
         * @param length of its segment
         */
        public function OneCapsuleFitter(radius:Number, length:Number)
        {
            super("upright capsule " + radius + " " + length);
            _radius = radius;
            _length = length;
        }

        override protected function findStructure(session:FitSession):BoundingStructure
        {
            return new Capsule(new Vector3D(0, 0, _radius), new Vector3D(0, 0, _radius + _length), _radius);
        }
    }
}
