package starlogo.away3d
{
    import away3d.containers.ObjectContainer3D;
    import away3d.core.base.Geometry;
    import away3d.core.base.ISubGeometry;
    import away3d.entities.Mesh;
    import flash.utils.getQualifiedClassName;
    import starlogo.geometry.AffineTransform;
    import starlogo.geometry.vertices.PointTable;
    import starlogo.models.Model;
    import starlogo.models.ModelError;
    import starlogo.models.building.FormatReader;
    import starlogo.models.building.ModelData;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Reads the source of an Away3dModel, in steps of about a millisecond. */
    internal final class SourceReader extends StepSequence implements FormatReader
    {
        // swaps y and z, which mirrors
        private static const SWAP:AffineTransform = new AffineTransform(new <Number>[1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0]);

        private var _data:ModelData;
        private var _object:Object;
        private var _parts:Vector.<PartReader> = new Vector.<PartReader>();

        /**
         * @param name the model's name
         * @param object as for Away3dModel
         */
        public function SourceReader(name:String, object:Object)
        {
            _data = ModelData.forFile(name, "z", Model.FOOTPRINT);
            _object = object;
            begin(readingParts);
        }

        /** @inheritDoc */
        public function get data():ModelData
        {
            return _data;
        }

        private function readingParts():Steps
        {
            addSource(_object);
            var vertexCount:int = 0;
            var hasTriangles:Boolean = false;
            for each (var part:PartReader in _parts)
            {
                vertexCount += part.vertexCount;
                hasTriangles ||= part.triangleCount > 0;
            }
            var points:PointTable = new PointTable(vertexCount);
            _data.vertices = points.coordinates;
            return new StepSequence().beginEach(_parts.length, function(index:int):Steps
                {
                    var setShare:Function = function(share:Number):void
                    {
                        _data.readProgress = (index + share) / _parts.length;
                    };
                    return hasTriangles ? _parts[index].readingTriangles(points, _data.triangles, setShare) : _parts[index].readingVertices(points, setShare);
                });
        }

        private function addSource(source:Object):void
        {
            if (source is ObjectContainer3D)
            {
                addTree(ObjectContainer3D(source), SWAP);
            }
            else if (source is Geometry)
            {
                addGeometry(Geometry(source), SWAP);
            }
            else if (source is ISubGeometry)
            {
                addPart(ISubGeometry(source), SWAP);
            }
            else if (source is Array || source is Vector.<*>)
            {
                for each (var each:Object in source)
                {
                    addSource(each);
                }
            }
            else
            {
                throw new ModelError(_data.name, "", "expected an ObjectContainer3D, a Geometry, an ISubGeometry or a list of them, not "
                        + (source == null ? "null" : getQualifiedClassName(source).replace("::", ".")));
            }
        }

        private function addTree(node:ObjectContainer3D, transform:AffineTransform):void
        {
            if (node is Mesh)
            {
                addGeometry(Mesh(node).geometry, transform);
            }
            for (var i:int = 0; i < node.numChildren; i++)
            {
                var child:ObjectContainer3D = node.getChildAt(i);
                addTree(child, transform.after(NodeTransform.of(child)));
            }
        }

        private function addGeometry(geometry:Geometry, transform:AffineTransform):void
        {
            for each (var part:ISubGeometry in geometry == null ? null : geometry.subGeometries)
            {
                addPart(part, transform);
            }
        }

        private function addPart(part:ISubGeometry, transform:AffineTransform):void
        {
            _parts.push(new PartReader(_data.name, part, transform));
        }
    }
}
