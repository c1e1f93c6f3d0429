package starlogo.away3d
{
    import away3d.core.base.Object3D;
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.AffineTransform;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /** The transform of an Away3D object in its container, in Away3D's axes. */
    internal final class NodeTransform
    {
        /**
         * The transform of an object. It is computed from the object's traits, because a Matrix3D has single precision in Flash Player. If
         * the object's matrix differs, the matrix counts, because Away3D draws with it. For example, the DAEParser sets only the matrix.
         */
        internal static function of(object:Object3D):AffineTransform
        {
            var traits:Vector.<Number> = ofTraits(object).rows;
            var columns:Vector.<Number> = object.transform.rawData;
            var drawn:Vector.<Number> = new Vector.<Number>(12);
            // the largest number so far
            var largest:Number = 0;
            var difference:Number = 0;
            var areSame:Boolean = true;
            for (var column:int = 0; column < 4; column++)
            {
                for (var row:int = 0; row < 3; row++)
                {
                    var at:int = 4 * row + column;
                    drawn[at] = columns[4 * column + row];
                    largest = Math.max(largest, Math.abs(traits[at]));
                    difference = Math.max(difference, Math.abs(traits[at] - drawn[at]));
                }
                // The comparison allows for single precision: relative to the scale in the first three columns, and in the fourth to the position or
                // the scale, whichever is larger.
                if (column >= 2)
                {
                    areSame = areSame && difference <= largest * Tolerances.SINGLE_PRECISION;
                    difference = 0;
                }
            }
            return new AffineTransform(areSame ? traits : drawn);
        }

        // First the scale, then the turn about the pivot point, then the move: T(position) T(pivot) R T(-pivot) S.
        private static function ofTraits(object:Object3D):AffineTransform
        {
            var p:Placement = new Placement();
            var pivot:Vector3D = object.pivotPoint;
            p.setRotation(object.rotationZ, object.rotationY, object.rotationX);
            var turned:Vector3D = new Vector3D();
            p.turn(pivot, turned);
            return AffineTransform.of(p, object.scaleX, object.scaleY, object.scaleZ,
                    object.x + pivot.x - turned.x, object.y + pivot.y - turned.y, object.z + pivot.z - turned.z);
        }
    }
}
