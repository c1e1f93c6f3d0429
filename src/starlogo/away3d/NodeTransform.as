package starlogo.away3d
{
    import away3d.core.base.Object3D;
    import flash.geom.Vector3D;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.models.AffineTransform;

    /** Where an object of Away3D's is in the object that contains it, in Away3D's axes. */
    internal final class NodeTransform
    {
        private static var sPlacement:Placement = new Placement();
        private static var sMatrix:Vector.<Number> = new Vector.<Number>(16, true);

        /** All is static. */
        public function NodeTransform()
        {
        }

        /**
         * The transform of an object. It is computed from the object's traits, because a Matrix3D has single precision in Flash Player. Where
         * the object's matrix says something else, the matrix counts, because Away3D draws that: its DAEParser writes there alone.
         */
        internal static function of(object:Object3D):AffineTransform
        {
            var traits:Vector.<Number> = ofTraits(object).rows;
            var drawn:Vector.<Number> = new Vector.<Number>(12);
            var scale:Number = 0;
            var difference:Number = 0;
            var areSame:Boolean = true;
            object.transform.copyRawDataTo(sMatrix);
            for (var column:int = 0; column < 4; column++)
            {
                for (var row:int = 0; row < 3; row++)
                {
                    var at:int = 4 * row + column;
                    drawn[at] = sMatrix[4 * column + row];
                    scale = Math.max(scale, Math.abs(traits[at]));
                    difference = Math.max(difference, Math.abs(traits[at] - drawn[at]));
                }
                // up to what single precision leaves of it: of the scale in three columns, of the position in the fourth
                if (column >= 2)
                {
                    areSame = areSame && difference <= scale * Tolerances.SINGLE_PRECISION;
                    difference = 0;
                }
            }
            return areSame ? new AffineTransform(traits) : new AffineTransform(drawn);
        }

        // Scaled, turned about the pivot point, moved: T(position) T(pivot) R T(-pivot) S.
        private static function ofTraits(object:Object3D):AffineTransform
        {
            var p:Placement = sPlacement;
            var pivot:Vector3D = object.pivotPoint;
            p.setRotation(object.rotationZ, object.rotationY, object.rotationX);
            return AffineTransform.of(p, object.scaleX, object.scaleY, object.scaleZ,
                    object.x + pivot.x - (p.r00 * pivot.x + p.r01 * pivot.y + p.r02 * pivot.z),
                    object.y + pivot.y - (p.r10 * pivot.x + p.r11 * pivot.y + p.r12 * pivot.z),
                    object.z + pivot.z - (p.r20 * pivot.x + p.r21 * pivot.y + p.r22 * pivot.z));
        }
    }
}
