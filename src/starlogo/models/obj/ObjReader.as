package starlogo.models.obj
{
    import starlogo.models.building.ModelReader;
    import starlogo.models.building.TriangleLabels;
    import starlogo.models.building.removingUnusedVertices;
    import starlogo.models.files.ModelFile;
    import starlogo.models.files.refuseModelIf;
    import starlogo.models.files.shortened;
    import starlogo.models.polygons.Triangulator;
    import starlogo.models.text.Decimal;
    import starlogo.models.text.LineReader;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads the statements of Wavefront OBJ text. ObjModel says which.
     *
     * @private
     */
    public final class ObjReader extends ModelReader
    {
        private var _lines:LineReader;

        // The faces of more than three corners are kept until all vertices are known: the corners, and two labels of each face, of its material and of
        // its mesh. Then the most triangles that they can have.
        private var _polygons:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
        private var _polygonLabels:Vector.<int> = new Vector.<int>();
        private var _polygonTriangles:int = 0;

        // The highest index of a vertex in a face, and its line.
        private var _highestIndex:int = -1;
        private var _highestLine:int;

        /** The other parameters are those of ObjModel. */
        public function ObjReader(file:ModelFile, upAxis:Object, scaling:String)
        {
            super(file.name, upAxis, scaling);
            var text:String = file.requireText();
            refuseModelIf(text.indexOf("\u0000") >= 0, file.name, "this is a binary file, not OBJ text");
            refuseModelIf(file.beginsWithTag, file.name, "this is no OBJ text: it begins with a tag. A ColladaModel reads COLLADA");
            _lines = new LineReader(this, text, readStatement);
            add(_lines).call(checkIndices).begin(triangulating).add(removingUnusedVertices(data.vertices, data.triangles));
        }

        private function readStatement(words:Array):void
        {
            switch (words[0])
            {
                case "v":
                    _lines.readPoint(words, 1, data.vertices, data.vertices.length);
                    break;
                case "f":
                    readFace(words);
                    break;
                case "usemtl":
                    readLabel(words, data.materials);
                    break;
                case "o":
                    readLabel(words, data.meshes);
                    break;
                case "g":
                    readLabel(words, data.meshes);
            }
        }

        // Gives the triangles that follow a label with the name in the rest of a statement. If there is no name, they have none.
        private function readLabel(words:Array, labels:TriangleLabels):void
        {
            var name:String = words.slice(1).join(" ");
            labels.beginRun(name == "" ? -1 : labels.labelWithKey(name, name), data.triangles.length / 3);
        }

        private function readFace(words:Array):void
        {
            var corners:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 1; i < words.length; i++)
            {
                corners.push(readCorner(words[i]));
            }
            if (corners.length == 3)
            {
                data.triangles.push(corners[0], corners[1], corners[2]);
            }
            else if (corners.length > 3)
            {
                _polygons.push(corners);
                _polygonLabels.push(data.materials.current, data.meshes.current);
                _polygonTriangles += corners.length - 2;
                _lines.budget.checkMeshSize(0, data.triangles.length / 3 + _polygonTriangles, _lines);
            }
        }

        // Reads a face's corner: 1, 1/2, 1//3 or 1/2/3. Returns its vertex's index, and notes the highest one.
        private function readCorner(word:String):int
        {
            var slash:int = word.indexOf("/");
            var value:Number = Decimal.of(slash < 0 ? word : word.substr(0, slash));
            var index:int = int(value);
            if (index != value || index == 0)
            {
                throw _lines.error("expected a vertex's number in a face's corner (1, 1/2, 1//3 or 1/2/3; not 0), but found \"" + shortened(word) + "\"");
            }
            index = index > 0 ? index - 1 : data.vertices.length / 3 + index;
            if (index < 0)
            {
                throw _lines.error("the corner \"" + shortened(word) +
                        "\" counts back beyond the first vertex: there are " + data.vertices.length / 3 + " before it");
            }
            if (index > _highestIndex)
            {
                _highestIndex = index;
                _highestLine = _lines.line;
            }
            return index;
        }

        private function checkIndices():void
        {
            var vertexCount:int = data.vertices.length / 3;
            refuseModelIf(vertexCount == 0, data.name, "no vertices, so this is no OBJ text: expected lines such as \"v 1 2 3\"");
            refuseModelIf(_highestIndex >= vertexCount, data.name, "there is no vertex " + (_highestIndex + 1) + ": the file has " + vertexCount, LineReader.placeOf(_highestLine));
        }

        // The steps that triangulate all polygons.
        private function triangulating():Steps
        {
            var triangulator:Triangulator = new Triangulator(_lines.budget, data.vertices, data.triangles);
            return new StepSequence().beginEach(_polygons.length, function(index:int):Steps
                {
                    data.materials.beginRun(_polygonLabels[2 * index], data.triangles.length / 3);
                    data.meshes.beginRun(_polygonLabels[2 * index + 1], data.triangles.length / 3);
                    return triangulator.addPolygon(_polygons[index]);
                }, Triangulator.POLYGONS_PER_STEP);
        }
    }
}
