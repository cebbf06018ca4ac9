/** A model of another view for the stage: the detail of the event stage-model. */
export interface StagedModel {
  /** The document of the model. */
  text: Promise<string>;
  /** The name of its file, without an ending. */
  name: string;
  /** Whether it was made here and is on no disk. */
  made: boolean;
}
