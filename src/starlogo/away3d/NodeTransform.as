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
         * The transform of an object. It is computed from the object's components, because a Matrix3D has single precision in Flash Player. If
         * the object's matrix differs, the matrix counts, because Away3D draws with it. For example, the DAEParser sets only the matrix.
         */
        internal static function of(object:Object3D):AffineTransform
        {
            var components:Vector.<Number> = ofComponents(object).rows;
            var columns:Vector.<Number> = object.transform.rawData;
            var drawn:Vector.<Number> = new Vector.<Number>(12);
            // of the scale in the first three columns, and of the place in the fourth
            var largest:Array = [0, 0];
            var difference:Array = [0, 0];
            for (var i:int = 0; i < 12; i++)
            {
                var part:int = i % 4 < 3 ? 0 : 1;
                drawn[i] = columns[4 * (i % 4) + int(i / 4)];
                largest[part] = Math.max(largest[part], Math.abs(components[i]));
                difference[part] = Math.max(difference[part], Math.abs(components[i] - drawn[i]));
            }
            // The comparison allows for single precision: of the scale, and for the place of the place or the scale, whichever is larger.
            var areSame:Boolean = difference[0] <= largest[0] * Tolerances.SINGLE_PRECISION
                && difference[1] <= Math.max(largest[0], largest[1]) * Tolerances.SINGLE_PRECISION;
            return new AffineTransform(areSame ? components : drawn);
        }

        // First the scale, then the rotation about the pivot point, then the move: T(position) T(pivot) R T(-pivot) S.
        private static function ofComponents(object:Object3D):AffineTransform
        {
            var p:Placement = new Placement();
            var pivot:Vector3D = object.pivotPoint;
            p.setRotation(object.rotationZ, object.rotationY, object.rotationX);
            var rotated:Vector3D = new Vector3D();
            p.rotate(pivot, rotated);
            return AffineTransform.of(p, object.scaleX, object.scaleY, object.scaleZ,
                    object.x + pivot.x - rotated.x, object.y + pivot.y - rotated.y, object.z + pivot.z - rotated.z);
        }
    }
}
