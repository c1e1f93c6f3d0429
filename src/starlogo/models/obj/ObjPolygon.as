package starlogo.models.obj
{
    /** A face with more than three corners, and the labels that its triangles get. */
    internal final class ObjPolygon
    {
        /** The vertex of each corner. Read only. */
        public var corners:Vector.<uint>;

        /** The label of its material. Read only. */
        public var material:int;

        /** The label of its mesh. Read only. */
        public var mesh:int;

        public function ObjPolygon(corners:Vector.<uint>, material:int, mesh:int)
        {
            this.corners = corners;
            this.material = material;
            this.mesh = mesh;
        }
    }
}
