package starlogo.queries.rays
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.NearestPoint;
    import starlogo.convex.SimplexPart;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.models.Model;
    import starlogo.models.building.TriangleLabels;
    import starlogo.queries.CastHit;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Writes what a ray or a cast tells of a row that it meets: the agent, the point and the normal, and the triangle there, with its mesh, its
     * material, and where on it the point is. It gives lists of hits their length, and keeps spare hits for lists that need more.
     *
     * @private
     */
    public final class HitWriter
    {
        private var _seen:SeenAgents;

        // RayHit or ShapeHit, and hits that no list needs at present.
        private var _type:Class;
        private var _spare:Array = [];

        // The point in the space of the model. From it to each corner of the triangle: x, y, z of each; and the triangle's point that is nearest to the point.
        private var _inModel:Vector3D = new Vector3D();
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);
        private var _nearest:NearestPoint = new NearestPoint();

        /**
         * @param seen has the rows
         * @param type RayHit or ShapeHit
         */
        public function HitWriter(seen:SeenAgents, type:Class)
        {
            _seen = seen;
            _type = type;
        }

        /**
         * Makes a list have as many hits as an answer. It removes surplus hits one at a time, because V8 frees an array's memory if its length is
         * set to less.
         *
         * @param hits a list of hits of the type
         */
        public function resize(hits:Object, length:int):void
        {
            while (hits.length > length)
            {
                var hit:Object = hits.pop();
                if (hit != null)
                {
                    hit.agent = null;
                    _spare.push(hit);
                }
            }
            for (var i:int = 0; i < length; i++)
            {
                if (i == hits.length || hits[i] == null)
                {
                    var next:Object = _spare.length > 0 ? _spare.pop() : new _type();
                    hits[i] = next;
                }
            }
        }

        /**
         * Writes a hit, all but its distance or time.
         *
         * @param row the row that is met
         * @param contact where it is met
         */
        public function write(row:int, contact:ContactPoint, hit:CastHit):void
        {
            hit.agent = _seen.table.listed.agentsByRow[row];
            // not setTo, because a game in JavaScript may have given a hit any objects with x, y and z
            hit.point.x = contact.x;
            hit.point.y = contact.y;
            hit.point.z = contact.z;
            hit.normal.x = contact.normalX;
            hit.normal.y = contact.normalY;
            hit.normal.z = contact.normalZ;
            hit.triangle = contact.triangle;
            writeTriangle(_seen.table.bodyOf(row), hit);
        }

        private function writeTriangle(body:Body, hit:CastHit):void
        {
            hit.mesh = hit.material = -1;
            hit.meshName = hit.materialName = null;
            _nearest.clearWeights();
            if (hit.triangle >= 0)
            {
                var model:Model = body.shape.model;
                var tree:BoxTree = body.shape.tree.boxTree;
                // the labels are those of the model's triangles, and a game may have made the hierarchy of other ones
                if (model != null && model.triangles == tree.triangles)
                {
                    var meshes:TriangleLabels = model.data.meshes;
                    var materials:TriangleLabels = model.data.materials;
                    hit.mesh = meshes.labelOf(hit.triangle);
                    hit.meshName = meshes.nameOf(hit.mesh);
                    hit.material = materials.labelOf(hit.triangle);
                    hit.materialName = materials.nameOf(hit.material);
                }
                readCorners(tree, 3 * hit.triangle, body.placement, hit.point);
                _nearest.squaredDistance = Infinity;
                SimplexPart.tryTriangle(_corners, 0, 1, 2, -1, _nearest);
            }
            hit.weights.x = weightOf(0);
            hit.weights.y = weightOf(1);
            hit.weights.z = weightOf(2);
        }

        // SimplexPart gives a corner that has no share of the point the weight LEAST_WEIGHT. Rounding may take the weight of a corner at the point above 1.
        private function weightOf(corner:int):Number
        {
            var weight:Number = _nearest.weights[corner];
            return weight > SimplexPart.LEAST_WEIGHT ? Math.min(1, weight) : 0;
        }

        private function readCorners(tree:BoxTree, corner:int, placement:Placement, point:Vector3D):void
        {
            var inModel:Vector3D = _inModel;
            inModel.x = (point.x - placement.x) / placement.size;
            inModel.y = (point.y - placement.y) / placement.size;
            inModel.z = (point.z - placement.z) / placement.size;
            Placement.rotateBack(placement, inModel, inModel);
            for (var i:int = 0; i < 3; i++)
            {
                var vertex:int = 3 * tree.triangles[corner + i];
                _corners[int(3 * i)] = tree.vertices[vertex] - inModel.x;
                _corners[int(3 * i + 1)] = tree.vertices[int(vertex + 1)] - inModel.y;
                _corners[int(3 * i + 2)] = tree.vertices[int(vertex + 2)] - inModel.z;
            }
        }
    }
}
